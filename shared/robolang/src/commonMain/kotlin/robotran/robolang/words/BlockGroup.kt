package robotran.robolang.words

/** The groups of lines and values. The palette has a page for each; a group also has its own colour and sign. */
enum class BlockGroup { DRIVE, PEN, SENSE, CONTROL, NUMBERS, LISTS, OWN_COMMANDS, SHOW_AND_SOUND }
