// Placeholder until the module lands.
namespace tetloft {}
