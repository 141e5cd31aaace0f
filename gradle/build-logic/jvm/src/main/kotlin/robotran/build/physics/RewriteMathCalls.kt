package robotran.build.physics

import org.gradle.api.GradleException
import org.gradle.api.provider.Property
import org.gradle.api.provider.SetProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.TaskAction
import robotran.build.teavm.RewriteLibrary

/**
 * Copies a jar and redirects calls of `java.lang.Math` functions whose last bit differs between platforms to one pure
 * Java implementation. Fails if the jar calls a function that is neither known to be exact nor replaced.
 */
@CacheableTask
abstract class RewriteMathCalls : RewriteLibrary() {
    /** The names of functions that IEEE 754 and the Java specification define exactly. */
    @get:Input
    abstract val exactFunctions: SetProperty<String>

    /** The names of functions to replace by functions of [replacement] with the same name and parameters. */
    @get:Input
    abstract val replacedFunctions: SetProperty<String>

    /** The internal name of the replacement class, such as `org/example/Functions`. */
    @get:Input
    abstract val replacement: Property<String>

    @TaskAction
    fun rewrite() {
        val rewriter = MathCallRewriter(exactFunctions.get(), replacedFunctions.get(), replacement.get())
        copy(rewritten = rewriter::rewrite)
        if (rewriter.unknownCalls.isNotEmpty()) {
            throw GradleException(
                "${library.singleFile.name} calls functions that may differ between platforms: " +
                    "${rewriter.unknownCalls}",
            )
        }
    }
}
