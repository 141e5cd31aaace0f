package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.Project
import org.gradle.api.file.RegularFile
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.DisableCachingByDefault
import javax.inject.Inject

/**
 * Runs a script that prints the paths of programs on this machine and installs missing ones where possible. Tests that
 * are skipped without these programs take [found] as an input, so that they run once the programs exist.
 */
@DisableCachingByDefault(because = "It asks the machine")
abstract class FindPrograms
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val script: RegularFileProperty

        /** The output of the script; empty if no program was found. */
        @get:OutputFile
        abstract val found: RegularFileProperty

        init {
            // Programs are installed and removed independently of the build.
            outputs.upToDateWhen { false }
        }

        @TaskAction
        fun find() {
            found.get().asFile.outputStream().use { file ->
                processes.exec {
                    it.commandLine(script.get().asFile.path)
                    it.standardOutput = file
                }
            }
        }

        companion object {
            /** The task that provides a virtual display for tests. */
            const val DISPLAY = "setUpDisplay"

            /** The task that finds or installs browsers other than Chromium. */
            const val ENGINES = "setUpEngines"

            /** The task that finds or installs Chromium. */
            const val CHROMIUM = "setUpChromium"

            /** Registers [DISPLAY] and [ENGINES] in the root project. */
            fun registerSetUp(root: Project) {
                register(
                    root,
                    DISPLAY,
                    "display.sh",
                    "Installs Xvfb for the tests that open a window, if it is missing and can be.",
                )
                register(
                    root,
                    ENGINES,
                    "engines.sh",
                    "Installs Firefox and WebKitGTK for the browser tests, if missing and possible.",
                )
                // apt can only run once at a time.
                root.tasks.named(DISPLAY) { it.mustRunAfter(CHROMIUM) }
                root.tasks.named(ENGINES) { it.mustRunAfter(CHROMIUM, DISPLAY) }
            }

            /** The programs found by [task], which is [DISPLAY] or [ENGINES]. */
            fun found(project: Project, task: String): Provider<RegularFile> =
                project.rootProject.tasks.named(task, FindPrograms::class.java).flatMap { it.found }

            private fun register(root: Project, name: String, script: String, description: String) {
                val isLinux = System.getProperty("os.name") == "Linux"
                root.tasks.register(name, FindPrograms::class.java) { task ->
                    task.group = "build setup"
                    task.description = description
                    task.script.set(root.file("gradle/bootstrap/web-tools/$script"))
                    task.found.set(root.layout.buildDirectory.file("programs/$name"))
                    task.onlyIf("elsewhere there are no packages of Debian") { isLinux }
                }
            }
        }
    }
