package robotran.brick.log

/** A call that shows something. */
internal data class ShownCall(
    override val milliseconds: Long,
    override val sourceLine: Int,
    override val sourceFile: String? = null,
    override val callText: String = "drawString hello 0 1",
    override val meaning: String = "show \"hello\"",
    override val group: CallGroup = CallGroup.DISPLAY,
    override val outcome: CallOutcome = CallOutcome.DONE,
) : LoggedCall {
    override fun identify(add: (Long) -> Unit) = add(milliseconds)
}
