package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.work.DisableCachingByDefault
import robotran.build.wasm.CalledFunctions

/** Writes the list for [SplitSkiko] from what the tests of the page have [recorded]. */
@DisableCachingByDefault(because = "It is run by hand, after a new version of Skiko")
abstract class ListCalledFunctions : DefaultTask() {
    /** The output of webpack and Kotlin's plugin, with the Skiko that was marked. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    /** Numbers of functions, one in a line, in any order and repeated. */
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val recorded: RegularFileProperty

    @get:OutputFile
    abstract val calledFunctions: RegularFileProperty

    @TaskAction
    fun list() {
        val skiko = BuiltApp(app.get().asFile).skiko.content
        val functions = recorded.get().asFile.readLines().filter { it.isNotEmpty() }.map { it.toInt() }.toSet()
        calledFunctions.get().asFile.writeText("${CalledFunctions(hexOf(sha256(skiko.readBytes())), functions)}")
    }
}
