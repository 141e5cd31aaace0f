package robotran.desktop

import java.awt.AWTError
import java.awt.GraphicsEnvironment
import java.awt.HeadlessException

/** Whether a display for windows exists and is reachable. */
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
