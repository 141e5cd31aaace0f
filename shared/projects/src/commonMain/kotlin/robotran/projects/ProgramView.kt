package robotran.projects

/** How a Robolang program is shown. Java programs are always text. */
enum class ProgramView {
    TEXT,
    BLOCKS,
    BOTH,
    ;

    val hasText: Boolean get() = this != BLOCKS
    val hasBlocks: Boolean get() = this != TEXT
}
