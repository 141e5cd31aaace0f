package robotran.nxt.storage

/** The state of a brick whose programs write files into its flash memory. */
interface HasFlash {
    /** In the order in which they were made. */
    val files: List<NxtFile>
}
