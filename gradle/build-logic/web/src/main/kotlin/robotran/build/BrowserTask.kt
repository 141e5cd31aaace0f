package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.process.ExecOperations
import org.gradle.process.ExecSpec
import java.io.ByteArrayOutputStream
import java.io.File

/** A task that runs Node scripts, which serve [page] and drive it in Chromium. */
abstract class BrowserTask(private val processes: ExecOperations) : DefaultTask() {
    /** The folder of the built page. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val page: DirectoryProperty

    /** A script that prints the path of a Chromium. */
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val browserFinder: RegularFileProperty

    @get:Internal
    abstract val node: Property<String>

    /** The folder with Playwright's driver. Its name changes with the pinned versions. */
    @get:Input
    abstract val modules: Property<String>

    init {
        dependsOn(":${WebTools.SET_UP_TASK}", ":${Chromium.SET_UP_TASK}")
        browserFinder.set(project.rootProject.file(Chromium.SCRIPT))
        node.set(WebTools.node(project).path)
        modules.set(WebTools.directory(project).resolve("node_modules").path)
    }

    /** Runs Node with [arguments] and sets environment variables for the browser, its driver and the page. */
    protected fun runNode(arguments: List<String>, configure: (ExecSpec) -> Unit = {}) {
        val browser = linesOf(browserFinder.get().asFile).first()
        processes.exec { exec ->
            exec.executable(node.get())
            exec.args(arguments)
            exec.environment("CHROMIUM", browser)
            exec.environment("NODE_PATH", modules.get())
            exec.environment("PAGE", page.get().asFile.path)
            configure(exec)
        }
    }

    /** The output of [script]. */
    private fun linesOf(script: File): List<String> {
        val said = ByteArrayOutputStream()
        processes.exec {
            it.commandLine(script.path)
            it.standardOutput = said
        }
        return said.toString().lines().filter { it.isNotBlank() }
    }
}
