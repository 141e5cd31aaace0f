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
 * The end of a command that takes time, such as stopping the motors after `forward`. It is done early if the command is
 * cut short, and not before [isOver].
 */
internal class CompletionAction(
    private val isOver: (Activity) -> Boolean = { true },
    private val end: (Activity) -> Unit,
) : StackInstruction {
    override fun execute(activity: Activity) = if (isOver(activity)) end(activity) else activity.lookAgain()

    fun cutShort(activity: Activity) = end(activity)
}
