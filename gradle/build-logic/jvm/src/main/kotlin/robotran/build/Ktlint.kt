package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.FileType
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.ChangeType
import org.gradle.work.Incremental
import org.gradle.work.InputChanges
import javax.inject.Inject

/** Runs ktlint on [files]. Fails if one is not in the project's style, or with [format] cannot be put into it. */
@CacheableTask
abstract class Ktlint
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        @get:Classpath
        abstract val classpath: ConfigurableFileCollection

        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        @get:Incremental
        abstract val files: ConfigurableFileCollection

        /** `.editorconfig`. */
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val style: RegularFileProperty

        /** The folder that reported paths are relative to. */
        @get:Internal
        abstract val root: DirectoryProperty

        /** Whether to change the files instead of only checking them. */
        @get:Input
        abstract val format: Property<Boolean>

        @get:OutputFile
        abstract val report: RegularFileProperty

        init {
            format.convention(false)
        }

        /** Only files that have changed since a run that found nothing; all of them when the style has changed. */
        @TaskAction
        fun run(changes: InputChanges) {
            val changed = changes.getFileChanges(files)
                .filter { it.changeType != ChangeType.REMOVED && it.fileType == FileType.FILE }
                .map { it.file }
            if (changed.isEmpty()) return
            val rootFolder = root.get().asFile
            val options =
                if (format.get()) {
                    listOf("--format")
                } else {
                    listOf("--reporter=plain", "--reporter=plain,output=${report.get().asFile}")
                }
            processes.javaexec { java ->
                java.classpath(classpath)
                java.mainClass.set("com.pinterest.ktlint.Main")
                // The quick compiler alone: a fifth of the time goes into optimising otherwise.
                val quick = listOf("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")
                java.jvmArgs(quick + listOf("-Xmx768m", "--add-opens=java.base/java.lang=ALL-UNNAMED"))
                java.workingDir = rootFolder
                java.args(listOf("--relative") + options)
                java.args(changed.map { it.relativeTo(rootFolder).invariantSeparatorsPath }.sorted())
            }
        }
    }
