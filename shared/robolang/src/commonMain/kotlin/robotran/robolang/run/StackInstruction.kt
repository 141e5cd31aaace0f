package robotran.robolang.run

/**
 * One instruction of the stack machine that programs run on. Most are small: they take their operands from the stack of
 * the [Activity] and leave the result there.
 */
internal fun interface StackInstruction {
    fun execute(activity: Activity)
}

/** Where an activity stops to be asked whether it may go on; nothing is done by it. */
internal sealed interface Boundary : StackInstruction {
    override fun execute(activity: Activity) = Unit

    /**
     * A statement of this line begins, or the next round of a loop; [known] are the variables there. It is one step of
     * the budget.
     */
    class Statement(val line: Int, val known: KnownVariables?) : Boundary

    /** The activity is over. */
    data object End : Boundary
}

/**
 * What ends a command that lasts, such as stopping the motors after `forward`. It is done early if the command is cut
 * short.
 */
internal class CompletionAction(private val end: (Activity) -> Unit) : StackInstruction {
    override fun execute(activity: Activity) = end(activity)
}
