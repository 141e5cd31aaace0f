package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import java.io.File

/**
 * Copies webpack's output with another [wasm] of the app. The name of the wasm, which contains a hash of it, is replaced
 * in the script.
 */
@CacheableTask
abstract class ReplaceWasm : DefaultTask() {
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val wasm: RegularFileProperty

    @get:OutputDirectory
    abstract val replaced: DirectoryProperty

    @TaskAction
    fun replace() {
        val output = replaced.get().asFile
        output.deleteRecursively()
        app.get().asFile.copyRecursively(output)
        val old = output.listFiles().orEmpty().single { NAME.matches(it.name) }
        old.delete()
        val new = wasm.get().asFile
        val name = "robotran.${hexOf(sha256(new.readBytes())).take(DIGITS)}.wasm"
        new.copyTo(output.resolve(name))
        rename(output.resolve("robotran.js"), old.name, name)
    }

    private fun rename(script: File, old: String, new: String) {
        val text = script.readText()
        if (old !in text) throw GradleException("${script.name} does not load $old.")
        script.writeText(text.replace(old, new))
    }

    private companion object {
        val NAME = Regex("""robotran\.[0-9a-f]{16}\.wasm""")
        const val DIGITS = 16
    }
}
