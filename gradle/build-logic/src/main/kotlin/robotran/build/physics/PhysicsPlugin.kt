package robotran.build.physics

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.artifacts.Configuration
import org.gradle.api.artifacts.VersionCatalogsExtension
import org.gradle.api.tasks.SourceSetContainer
import org.gradle.api.tasks.compile.JavaCompile

/**
 * The module that wraps dyn4j: a jar for JVM and Android, and the same classes as a WebAssembly module for the browser.
 *
 * dyn4j's mathematical functions are replaced by those of commons-math, see [RewriteMathCalls]. Only the rewritten dyn4j is on any class path.
 * The browser's files are offered to other modules as the configuration [WEB_FILES]; `robotran.physics-web` fetches them.
 */
class PhysicsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("java-library")
        val libraries = project.extensions.getByType(VersionCatalogsExtension::class.java).named("libs")

        fun library(name: String) = libraries.findLibrary(name).get()

        val original = project.toolConfiguration("originalDyn4j").apply { isTransitive = false }
        val teavm = project.toolConfiguration("teavm")
        val dependencies = project.dependencies
        dependencies.add(original.name, library("dyn4j"))
        dependencies.add(teavm.name, library("teavm-tooling"))

        val rewrite = project.tasks.register("rewriteDyn4j", RewriteMathCalls::class.java) {
            it.library.from(original)
            it.exactFunctions.set(EXACT_FUNCTIONS)
            it.replacedFunctions.set(REPLACED_FUNCTIONS)
            it.replacement.set("org/apache/commons/math3/util/FastMath")
            it.rewrittenLibrary.set(project.layout.buildDirectory.file("physics/dyn4j-with-fast-math.jar"))
        }
        dependencies.add("implementation", project.files(rewrite.map { it.rewrittenLibrary }))
        dependencies.add("implementation", library("commons-math"))

        val sourceSets = project.extensions.getByType(SourceSetContainer::class.java)
        val main = sourceSets.getByName("main")
        val browser = sourceSets.create("browser")
        dependencies.add(browser.implementationConfigurationName, main.output)
        dependencies.add(browser.implementationConfigurationName, library("teavm-jso"))
        dependencies.add(browser.runtimeOnlyConfigurationName, library("teavm-classlib"))

        val compile = project.tasks.register("compilePhysicsToWasm", CompileToWasm::class.java) {
            it.compiler.from(teavm)
            it.program.from(browser.runtimeClasspath, main.runtimeClasspath)
            it.mainClass.set("robotran.physics.browser.PhysicsModule")
            it.moduleName.set("physics")
            it.glue.set(project.layout.projectDirectory.file("src/browser/javascript/physics.mjs"))
            it.outputFolder.set(project.layout.buildDirectory.dir("physics/web"))
        }
        project.configurations.create(WEB_FILES) {
            it.isCanBeResolved = false
            it.isCanBeConsumed = true
            it.outgoing.artifact(compile.flatMap { task -> task.outputFolder })
        }
        // A constant of one file may be compiled into another, which incremental compilation does not always notice.
        project.tasks.withType(JavaCompile::class.java).configureEach { it.options.isIncremental = false }
    }

    private fun Project.toolConfiguration(name: String): Configuration = configurations.create(name) {
        it.isCanBeConsumed = false
        it.isCanBeResolved = true
    }

    companion object {
        /** The configuration of the physics module that holds the folder of files for the browser. */
        const val WEB_FILES = "physicsWeb"

        private val EXACT_FUNCTIONS = setOf("abs", "max", "min", "floor", "ceil", "rint", "sqrt", "signum", "getExponent")
        private val REPLACED_FUNCTIONS = setOf(
            "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "cbrt", "hypot", "exp", "log", "log10", "pow", "toRadians", "toDegrees",
        )
    }
}
