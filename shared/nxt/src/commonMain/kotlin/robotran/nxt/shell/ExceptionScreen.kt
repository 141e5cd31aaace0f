package robotran.nxt.shell

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramFailure
import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Drawing
import robotran.nxt.state.ExceptionView

/**
 * What leJOS NXJ shows of an exception that nobody catches: numbers of its class, and of each method with the place in
 * its code, also of the exceptions that caused it. A text has one row and is cut off at the edge. A failure without a
 * stack, of a language without numbers, shows its line. LEFT and RIGHT move the text.
 */
internal class ExceptionScreen(private val failure: ProgramFailure) {
    private val rows = rowsOf(failure)
    private var firstRow = 0

    val view: ExceptionView get() = ExceptionView(failure, firstRow)

    fun press(button: BrickButton) {
        val last = maxOf(0, rows.size - DisplaySize.ROWS)
        when (button) {
            BrickButton.LEFT -> firstRow = maxOf(0, firstRow - 1)
            BrickButton.RIGHT -> firstRow = minOf(last, firstRow + 1)
            else -> Unit
        }
    }

    fun draw(memory: DisplayMemory) {
        rows.drop(firstRow).take(DisplaySize.ROWS).forEachIndexed { row, text ->
            Drawing.drawString(memory, text, 0, row)
        }
    }

    private fun rowsOf(failure: ProgramFailure): List<String> = buildList {
        if (failure.exceptionNumber == 0 && failure.stack.isEmpty()) {
            add("Program stopped")
            if (failure.sourceLine > 0) add("in line ${failure.sourceLine}")
        } else {
            add("Exception: ${failure.exceptionNumber}")
            failure.thrownText?.let { add(it.lineSequence().first()) }
            for (frame in failure.stack) add(rowOf(frame.methodNumber, frame.offset))
            for (cause in failure.causes) {
                add("Caused by: ${cause.exceptionNumber}")
                cause.thrownText?.let { add(it.lineSequence().first()) }
                for (call in cause.calls) add(rowOf(call.methodNumber, call.offset))
            }
        }
    }

    private fun rowOf(methodNumber: Int, offset: Int) = " at:${"$methodNumber".padStart(NUMBER_WIDTH)}:$offset"

    private companion object {
        const val NUMBER_WIDTH = 5
    }
}
