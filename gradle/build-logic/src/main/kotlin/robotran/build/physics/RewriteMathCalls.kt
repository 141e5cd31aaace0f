package robotran.build.physics

import org.gradle.api.GradleException
import org.gradle.api.provider.Property
import org.gradle.api.provider.SetProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.TaskAction
import robotran.build.teavm.RewriteLibrary

/**
 * Copies a jar and lets its calls of `java.lang.Math` functions whose last bit differs from platform to platform go to
 * one implementation in pure Java. Fails if the jar calls a function that is neither known to be exact nor replaced.
 */
@CacheableTask
abstract class RewriteMathCalls : RewriteLibrary() {
    /** Names of the functions that IEEE 754 and Java's definition leave no freedom to, so that they may stay. */
    @get:Input
    abstract val exactFunctions: SetProperty<String>

    /** Names of the functions to replace by those of the same name and parameters in [replacement]. */
    @get:Input
    abstract val replacedFunctions: SetProperty<String>

    /** Internal name of the class that is called instead, such as `org/example/Functions`. */
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
