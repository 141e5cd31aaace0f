package robotran.build

import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.DisableCachingByDefault
import javax.inject.Inject

/** Opens the built page in Chromium and prints the measurements of [script]. */
@DisableCachingByDefault(because = "What is measured is another thing each time")
abstract class MeasurePage
    @Inject
    constructor(processes: ExecOperations) : BrowserTask(processes) {
        @get:InputFile
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val script: RegularFileProperty

        /** The measurements to run; empty for all. */
        @get:Input
        abstract val names: ListProperty<String>

        @TaskAction
        fun measure() = runNode(listOf(script.get().asFile.path) + names.get())
    }
