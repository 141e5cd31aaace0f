package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.DisableCachingByDefault
import java.io.ByteArrayOutputStream
import javax.inject.Inject

/** Opens the built page in Chromium and prints what [script] measures of it. */
@DisableCachingByDefault(because = "What is measured is another thing each time")
abstract class MeasurePage
    @Inject
    constructor(
        private val processes: ExecOperations,
    ) : DefaultTask() {
        /** The folder that is put on a web server. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val page: DirectoryProperty

        @get:InputFile
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val script: RegularFileProperty

        /** What is measured; if empty, everything. */
        @get:Input
        abstract val names: ListProperty<String>

        /** A script that prints the path of a Chromium. */
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val browserFinder: RegularFileProperty

        @get:Internal
        abstract val node: Property<String>

        /** The folder that holds Playwright's driver. */
        @get:Internal
        abstract val modules: Property<String>

        @TaskAction
        fun measure() {
            val browser = ByteArrayOutputStream()
            processes.exec {
                it.commandLine(browserFinder.get().asFile.path)
                it.standardOutput = browser
            }
            processes.exec {
                it.commandLine(node.get(), script.get().asFile.path)
                it.args(names.get())
                it.environment("CHROMIUM", browser.toString().trim())
                it.environment("NODE_PATH", modules.get())
                it.environment("PAGE", page.get().asFile.path)
            }
        }
    }
