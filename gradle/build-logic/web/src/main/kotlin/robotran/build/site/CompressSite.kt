package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import robotran.build.WebTools
import javax.inject.Inject

/**
 * Copies [page] to [site] and adds a Brotli and a gzip file beside each file that they make smaller, for servers that
 * send such files as they are. The highest levels of compression take half a minute, too long for a server.
 */
@CacheableTask
abstract class CompressSite
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val page: DirectoryProperty

        @get:OutputDirectory
        abstract val site: DirectoryProperty

        @get:Internal
        abstract val node: Property<String>

        init {
            dependsOn(":${WebTools.SET_UP_TASK}")
            node.set(WebTools.node(project).path)
        }

        @TaskAction
        fun compress() {
            val output = site.get().asFile
            val earlier = temporaryDir.resolve("earlier")
            val script = temporaryDir.resolve("compress.mjs")
            earlier.deleteRecursively()
            if (output.exists()) output.renameTo(earlier)
            page.get().asFile.copyRecursively(output)
            script.writeText(checkNotNull(CompressSite::class.java.getResource("compress.mjs")).readText())
            processes.exec { it.commandLine(node.get(), script.path, output.path, earlier.path) }
            earlier.deleteRecursively()
        }
    }
