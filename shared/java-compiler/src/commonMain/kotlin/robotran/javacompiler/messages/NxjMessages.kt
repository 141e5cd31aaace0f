package robotran.javacompiler.messages

/** The messages about what an NXT with leJOS NXJ lacks. */
interface NxjMessages {
    /** What to use instead; a sentence or two. */
    fun insteadInNxj(remedy: NxjRemedy): String
}
