package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.Exec
import java.io.ByteArrayOutputStream

/** The browser that the web page is tested in, and the other engines that it is to run in. */
object Chromium {
    /** The task of the root project that sees to it that there is one. */
    const val SET_UP_TASK = "setUpChromium"

    /** Prints its path, and installs it where it is missing. */
    const val SCRIPT = "gradle/web-tools/chromium.sh"

    /** The task that sees to it that the other engines are there in which it is tested. */
    const val ENGINES_TASK = "setUpEngines"

    /** Prints where they are, and installs what is missing where it can. */
    const val ENGINES_SCRIPT = "gradle/web-tools/engines.sh"

    /** Registers [SET_UP_TASK] and [ENGINES_TASK] in the root project. */
    fun registerSetUp(root: Project) {
        root.tasks.register(SET_UP_TASK, Exec::class.java) { task ->
            task.group = "build setup"
            task.description = "Installs Chromium for the browser tests, if there is none."
            task.commandLine(root.file(SCRIPT).path)
        }
        root.tasks.register(ENGINES_TASK, Exec::class.java) { task ->
            task.group = "build setup"
            task.description = "Installs Firefox and WebKitGTK for the browser tests, if they are missing and can be."
            // One apt at a time.
            task.mustRunAfter(SET_UP_TASK)
            task.commandLine(root.file(ENGINES_SCRIPT).path)
            task.standardOutput = ByteArrayOutputStream()
        }
    }
}
