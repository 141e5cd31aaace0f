package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.Exec

/** The browser that tests the web page. */
object Chromium {
    /** The task of the root project that finds or installs Chromium. */
    const val SET_UP_TASK = FindPrograms.CHROMIUM

    /** Prints the path of Chromium and installs it if missing. */
    const val SCRIPT = "gradle/bootstrap/web-tools/chromium.sh"

    /** Registers [SET_UP_TASK] in the root project. */
    fun registerSetUp(root: Project) {
        root.tasks.register(SET_UP_TASK, Exec::class.java) { task ->
            task.group = "build setup"
            task.description = "Installs Chromium for the browser tests, if there is none."
            task.commandLine(root.file(SCRIPT).path)
        }
    }
}
