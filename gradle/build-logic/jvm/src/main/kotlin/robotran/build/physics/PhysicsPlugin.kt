package robotran.build.physics

import org.gradle.api.Plugin
import org.gradle.api.Project
import robotran.build.Targets
import robotran.build.catalog
import robotran.build.teavm.configureJavaModule
import robotran.build.teavm.toolConfiguration

/**
 * The module that wraps dyn4j: a jar for JVM and Android, and the same classes as a WebAssembly module for the browser.
 *
 * Its mathematical functions are replaced by those of commons-math, see [RewriteMathCalls]. Only the rewritten dyn4j is
 * on any class path.
 */
class PhysicsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        configureJavaModule(project)
        val libraries = catalog(project)
        val original = toolConfiguration(project, "originalDyn4j").apply { isTransitive = false }
        val dependencies = project.dependencies
        dependencies.add(original.name, libraries.findLibrary("dyn4j").get())

        val rewrite = project.tasks.register("rewriteDyn4j", RewriteMathCalls::class.java) {
            it.library.from(original)
            it.exactFunctions.set(EXACT_FUNCTIONS)
            it.replacedFunctions.set(REPLACED_FUNCTIONS)
            it.replacement.set("org/apache/commons/math3/util/FastMath")
            it.rewrittenLibrary.set(project.layout.buildDirectory.file("physics/dyn4j-with-fast-math.jar"))
        }
        dependencies.add("implementation", project.files(rewrite.map { it.rewrittenLibrary }))
        dependencies.add("implementation", libraries.findLibrary("commons-math").get())
        if (Targets.of(project).wasm) project.pluginManager.apply("robotran.physics-module")
    }

    private companion object {
        val EXACT_FUNCTIONS = setOf("abs", "max", "min", "floor", "ceil", "rint", "sqrt", "signum", "getExponent")
        val REPLACED_FUNCTIONS = setOf(
            "sin",
            "cos",
            "tan",
            "asin",
            "acos",
            "atan",
            "atan2",
            "cbrt",
            "hypot",
            "exp",
            "log",
            "log10",
            "pow",
            "toRadians",
            "toDegrees",
        )
    }
}
