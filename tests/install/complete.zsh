# What zsh shows where Tab is pressed twice behind a line: zsh -f complete.zsh FOLDER LINE, where
# FOLDER holds the completion.
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -u -D; PS1=; print re''ady"
shown=
while zpty -r shell chunk; do
  shown+=$chunk
  [[ $shown == *ready* ]] && break
done
zpty -w -n shell "$2"$'\t\t'
sleep 1
zpty -w -n shell $'\025exit\n'
shown=
while zpty -r shell chunk; do shown+=$chunk; done
print -r -- $shown
