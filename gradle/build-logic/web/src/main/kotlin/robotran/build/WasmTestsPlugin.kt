package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import org.jetbrains.kotlin.gradle.tasks.Kotlin2JsCompile
import java.io.File

/**
 * Compiles the wasm tests of all core modules together, links them to one executable, and runs it in Node. Linking takes
 * most of the time of a wasm test and includes all libraries each time, so one link replaces one for each module.
 *
 * The project `wasmTests` holds the contract: the tests in `src/contractTest` of each module, about what may depend on the
 * target. `allWasmTests`, in `checkAll`, holds all.
 */
class WasmTestsPlugin : Plugin<Project> {
    @OptIn(ExperimentalWasmDsl::class)
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        project.pluginManager.apply("robotran.physics-web")
        project.pluginManager.apply("robotran.ecj-web")
        WebTools.use(project)
        val hasAll = project.name == ALL
        leaveOutOfCheck(project, *if (hasAll) arrayOf("allTests", RUN) else arrayOf("allTests"))
        if (hasAll) Rings.addToAll(project, RUN)
        val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
        kotlin.wasmJs { nodejs() }
        kotlin.sourceSets.getByName("wasmJsTest").dependencies {
            implementation(kotlin("test"))
            implementation(catalog(project).findLibrary("coroutines-test").get())
        }
        if (!hasAll) kotlin.sourceSets.getByName("wasmJsTest").kotlin.exclude { isOtherTest(it.file) }
        project.rootProject.subprojects { module ->
            module.pluginManager.withPlugin("robotran.core") { include(module, project, kotlin) }
        }
    }

    private fun include(module: Project, project: Project, kotlin: KotlinMultiplatformExtension) {
        val tests = kotlin.sourceSets.getByName("wasmJsTest")
        tests.dependencies { implementation(project.dependencies.project(mapOf("path" to module.path))) }
        val theirs = module.extensions.getByType(KotlinMultiplatformExtension::class.java)
        for (name in listOf("commonTest", "wasmJsTest")) {
            tests.kotlin.srcDir(theirs.sourceSets.getByName(name).kotlin.sourceDirectories)
        }
        // Tests use what is internal in their module.
        val main = module.tasks.named("compileKotlinWasmJs", Kotlin2JsCompile::class.java)
        project.tasks.named("compileTestKotlinWasmJs", Kotlin2JsCompile::class.java) { compile ->
            compile.friendPaths.from(main.flatMap { it.destinationDirectory })
        }
    }

    /** A test that is not in the contract. Other files may hold what tests share. */
    private fun isOtherTest(file: File): Boolean =
        file.name.endsWith("Test.kt") && "/src/contractTest/" !in file.invariantSeparatorsPath

    private companion object {
        const val ALL = "allWasmTests"
        const val RUN = "wasmJsNodeTest"
    }
}
