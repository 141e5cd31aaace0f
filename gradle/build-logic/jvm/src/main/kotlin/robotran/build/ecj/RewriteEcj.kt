package robotran.build.ecj

import org.gradle.api.GradleException
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.TaskAction
import robotran.build.teavm.RewriteLibrary

/**
 * Copies ECJ's jar without the parts for its command line, Ant, Eclipse and annotation processors. [EcjRewriter]
 * changes the rest.
 */
@CacheableTask
abstract class RewriteEcj : RewriteLibrary() {
    @TaskAction
    fun rewrite() {
        val rewriter = EcjRewriter()
        copy(isKept = { path -> EXCLUDED_PREFIXES.none { path.startsWith(it) } }, rewritten = rewriter::rewrite)
        if (rewriter.missing.isNotEmpty()) {
            throw GradleException("${library.singleFile.name} does not have ${rewriter.missing}")
        }
    }

    private companion object {
        val EXCLUDED_PREFIXES = listOf(
            "META-INF/services/",
            "ecj.1",
            "org/eclipse/jdt/core/BuildJarIndex",
            "org/eclipse/jdt/core/CheckDebugAttributes",
            "org/eclipse/jdt/core/JDTCompilerAdapter",
            "org/eclipse/jdt/core/compiler/batch/",
            "org/eclipse/jdt/internal/antadapter/",
            "org/eclipse/jdt/internal/compiler/ExtraFlags",
            "org/eclipse/jdt/internal/compiler/SourceElementNotifier",
            "org/eclipse/jdt/internal/compiler/apt/",
            "org/eclipse/jdt/internal/compiler/batch/",
            "org/eclipse/jdt/internal/compiler/tool/",
        )
    }
}
