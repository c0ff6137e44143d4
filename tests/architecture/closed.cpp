// Nothing of its own: what is linked with it is what is tried.
