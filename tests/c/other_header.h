/* What the list does not know. */
int tetloft_new(void);
