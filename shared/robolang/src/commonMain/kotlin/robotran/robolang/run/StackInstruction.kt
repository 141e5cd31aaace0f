package robotran.robolang.run

/**
 * One instruction of the stack machine. Most pop their operands from the stack of the [Activity] and push the result.
 */
internal fun interface StackInstruction {
    fun execute(activity: Activity)
}

/** A point at which an activity can be stopped; it does nothing itself. */
internal sealed interface Boundary : StackInstruction {
    override fun execute(activity: Activity) = Unit

    /**
     * The start of a statement in this line, or of a loop's next round; [known] are the variables in scope. It is one
     * step of the budget.
     */
    class Statement(val line: Int, val known: KnownVariables?) : Boundary

    /** The activity is over. */
    data object End : Boundary
}

/**
 * The end of a timed command, such as stopping the motors after `forward`. It is executed early if the command is cut
 * short.
 */
internal class CompletionAction(private val end: (Activity) -> Unit) : StackInstruction {
    override fun execute(activity: Activity) = end(activity)
}
