package robotran.robolang.python.pybricks

import robotran.robolang.python.writer.PythonStrength
import robotran.robolang.python.writer.PythonText
import robotran.robolang.python.writer.primary

/** Awaits what takes time in a task. */
internal class PybricksAwaiting {
    /** Whether lines are written for a task, in which readings and calls that wait have to be awaited. */
    var isInTask = false

    /** [call], which is awaited in a task if it takes time. */
    fun waiting(call: String, isAwaited: Boolean = isInTask): PythonText =
        if (isAwaited) PythonText("await $call", PythonStrength.AWAIT) else primary(call)
}
