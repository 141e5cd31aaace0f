package robotran.build

import org.gradle.api.Project
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.services.BuildService
import org.gradle.api.services.BuildServiceParameters
import org.gradle.build.event.BuildEventsListenerRegistry
import org.gradle.tooling.events.FinishEvent
import org.gradle.tooling.events.OperationCompletionListener
import org.gradle.tooling.events.task.TaskFinishEvent
import org.gradle.tooling.events.task.TaskSuccessResult
import java.io.File
import javax.inject.Inject

/**
 * Writes `build/reports/task-times.tsv`, one line for each finished task, at once: its path, its start and end in
 * milliseconds since 1970, and whether it was executed, skipped or up to date, separated by tabs. `./robotran` shows its
 * progress from this file; `.ci/run` lists the slowest tasks.
 */
abstract class TaskTimes :
    BuildService<TaskTimes.Parameters>,
    OperationCompletionListener {
    interface Parameters : BuildServiceParameters {
        val report: RegularFileProperty
    }

    private val report: File = parameters.report.get().asFile

    init {
        report.parentFile.mkdirs()
        report.delete()
    }

    override fun onFinish(event: FinishEvent) {
        if (event !is TaskFinishEvent) return
        val result = event.result
        val outcome =
            when {
                result !is TaskSuccessResult -> "skipped"
                result.isFromCache -> "from cache"
                result.isUpToDate -> "up to date"
                else -> "executed"
            }
        val fields = listOf(event.descriptor.taskPath, result.startTime, result.endTime, outcome)
        synchronized(this) { report.appendText(fields.joinToString("\t", postfix = "\n")) }
    }

    /** Registers the service with a build. */
    abstract class Registration
        @Inject
        constructor(private val events: BuildEventsListenerRegistry) {
            fun register(root: Project) {
                val service =
                    root.gradle.sharedServices.registerIfAbsent("taskTimes", TaskTimes::class.java) {
                        it.parameters.report.set(root.layout.buildDirectory.file("reports/task-times.tsv"))
                    }
                events.onTaskCompletion(service)
            }
        }
}
