package robotran.build

import org.gradle.api.Project
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.TaskProvider
import org.jetbrains.kotlin.gradle.targets.js.ir.KotlinJsIrLink
import robotran.build.site.AssembleSite
import robotran.build.site.CompressSite
import robotran.build.site.ListCalledFunctions
import robotran.build.site.MarkSkiko
import robotran.build.site.OptimizeWasm
import robotran.build.site.ReplaceWasm
import robotran.build.site.SplitSkiko
import java.io.File

/** The tasks that make web sites of what Kotlin's plugin and webpack have made of the app. */
internal class SiteTasks(private val project: Project) {
    private val build = project.layout.buildDirectory
    private val calledFunctions = project.layout.projectDirectory.file("src/skiko/called-functions.txt")

    /** The output of webpack and Kotlin's plugin. */
    private val builtApp: Provider<File> =
        project.tasks.named("wasmJsBrowserDistribution").map { it.outputs.files.singleFile }

    private val split: TaskProvider<SplitSkiko> =
        project.tasks.register("splitSkiko", SplitSkiko::class.java) { task ->
            task.description = "Splits Skiko into what the app calls and the rest."
            task.app.fileProvider(builtApp)
            task.calledFunctions.set(calledFunctions)
            task.parts.set(build.dir("skiko-parts"))
        }

    init {
        project.tasks.withType(AssembleSite::class.java).configureEach {
            it.page.set(project.layout.projectDirectory.dir("src/site"))
        }
    }

    /** `assembleSite`: the site for tests, hardly optimised. */
    fun addSite(): TaskProvider<AssembleSite> {
        val app = replace("siteApp", "Puts the parts of Skiko into what webpack has made.", split.flatMap { it.parts })
        return project.tasks.register("assembleSite", AssembleSite::class.java) { task ->
            task.description = "Assembles the site for tests."
            task.app.set(app.flatMap { it.replaced })
            task.site.set(build.dir("assembled-site"))
        }
    }

    /** `assembleRelease`: the same, small and fast. `dist`: the folder to upload, with compressed files. */
    fun addRelease(): TaskProvider<AssembleSite> {
        val link = project.tasks.named(LINK, KotlinJsIrLink::class.java)
        val optimize = project.tasks.register("optimizeApp", OptimizeWasm::class.java) { task ->
            task.description = "Makes the app's wasm small and fast."
            task.linked.set(link.flatMap { it.destinationDirectory.file(APP) })
            task.arguments.set(WasmOptimisation.arguments(project, WasmOptimisation.RELEASE_PASSES))
            task.optimized.set(build.file("optimized-app/$APP"))
        }
        val app = replace(
            "releaseApp",
            "Puts the small and fast wasm and the parts of Skiko into what webpack has made.",
            split.flatMap { it.parts },
            optimize.flatMap { it.optimized },
        )
        val assemble = project.tasks.register("assembleRelease", AssembleSite::class.java) { task ->
            task.description = "Assembles the site for pupils, without compressed files."
            task.app.set(app.flatMap { it.replaced })
            task.site.set(build.dir("release-site"))
        }
        project.tasks.register("dist", CompressSite::class.java) { task ->
            task.group = "distribution"
            task.description = "Makes build/site, the folder to put on a web server."
            task.page.set(assemble.flatMap { it.site })
            task.site.set(build.dir("site"))
        }
        return assemble
    }

    /**
     * `recordSkiko`: runs the tests of the page to find the functions of Skiko that belong into its first part; run by
     * hand.
     */
    fun addRecording() {
        val mark = project.tasks.register("markSkiko", MarkSkiko::class.java) { task ->
            task.description = "Makes a Skiko that tells which of its functions are called."
            task.app.fileProvider(builtApp)
            task.marked.set(build.dir("marked-skiko"))
        }
        val app = replace("markedApp", "Puts the marked Skiko into what webpack has made.", mark.flatMap { it.marked })
        val site = project.tasks.register("assembleMarked", AssembleSite::class.java) { task ->
            task.description = "Assembles a site with the marked Skiko."
            task.app.set(app.flatMap { it.replaced })
            task.site.set(build.dir("marked-site"))
        }
        val calls = project.tasks.register("recordSkikoCalls", BrowserTest::class.java) { task ->
            task.description = "Drives the page and records which functions of Skiko it calls."
            task.page.set(site.flatMap { it.site })
            // Measures of size and requests do not fit a marked Skiko, and those tests call nothing else.
            task.tests.from(
                project.fileTree("src/browserTest") {
                    it.include("*.test.mjs")
                    it.exclude("compress.test.mjs", "loading.test.mjs", "offline.test.mjs")
                },
            )
            task.skikoCalls.set(build.file("skiko-calls.txt"))
            task.pictures.set(build.dir("marked-pictures"))
        }
        project.tasks.register("recordSkiko", ListCalledFunctions::class.java) { task ->
            task.group = "build setup"
            task.description = "Finds out which functions of Skiko the app calls, after a change of its version."
            task.app.fileProvider(builtApp)
            task.recorded.set(calls.flatMap { it.skikoCalls })
            task.calledFunctions.set(calledFunctions)
        }
    }

    private fun replace(name: String, description: String, vararg modules: Provider<*>): TaskProvider<ReplaceWasm> =
        project.tasks.register(name, ReplaceWasm::class.java) { task ->
            task.description = description
            task.app.fileProvider(builtApp)
            task.modules.from(*modules)
            task.replaced.set(build.dir(name))
        }

    companion object {
        /** The task of Kotlin's plugin that links the app, and the file that it makes. */
        const val LINK = "compileProductionExecutableKotlinWasmJs"
        const val APP = "robotran.wasm"
    }
}
