package robotran.ui.program.blocks

/** The smallest screen of each form; `thorough` has the others. */
class BlocksFitTest : BlocksOnScreens() {
    override val sizes = listOf(Size(360, 640), Size(640, 360), Size(1024, 768), Size(820, 1180))
}
