package robotran.desktop

import java.awt.AWTError
import java.awt.GraphicsEnvironment
import java.awt.HeadlessException

/** Whether there is a screen that a window can be opened on, and that it can be reached. */
internal fun hasDisplay(): Boolean {
    if (GraphicsEnvironment.isHeadless()) return false
    return try {
        GraphicsEnvironment.getLocalGraphicsEnvironment().screenDevices.isNotEmpty()
    } catch (_: HeadlessException) {
        false
    } catch (_: AWTError) {
        false
    }
}
