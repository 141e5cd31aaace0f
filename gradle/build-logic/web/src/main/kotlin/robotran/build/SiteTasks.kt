package robotran.build

import org.gradle.api.Project
import org.gradle.api.file.Directory
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.TaskProvider
import org.jetbrains.kotlin.gradle.targets.js.ir.KotlinJsIrLink
import robotran.build.site.AssembleSite
import robotran.build.site.CompressSite
import robotran.build.site.DividedModule
import robotran.build.site.MarkCalls
import robotran.build.site.OptimizeWasm
import robotran.build.site.ReplaceWasm
import robotran.build.site.SplitWasm
import java.io.File

/** The tasks that make web sites of what Kotlin's plugin and webpack have made of the app. */
internal class SiteTasks(private val project: Project) {
    private val build = project.layout.buildDirectory
    private val lists = project.layout.projectDirectory.dir("src/first-part")

    /** The output of webpack and Kotlin's plugin. */
    private val builtApp: Provider<File> =
        project.tasks.named("wasmJsBrowserDistribution").map { it.outputs.files.singleFile }

    private val splitSkiko = split("splitSkiko", DividedModule.SKIKO, project.layout.dir(builtApp))

    init {
        project.tasks.withType(AssembleSite::class.java).configureEach {
            it.page.set(project.layout.projectDirectory.dir("src/site"))
        }
    }

    /** `assembleSite`: the site for tests, hardly optimised. */
    fun addSite(): TaskProvider<AssembleSite> {
        val split = split("splitApp", DividedModule.APP, project.layout.dir(builtApp))
        val app = replace(
            "siteApp",
            "Puts the parts of the modules into what webpack has made.",
            splitSkiko.flatMap { it.parts },
            split.flatMap { it.parts },
        )
        return project.tasks.register("assembleSite", AssembleSite::class.java) { task ->
            task.description = "Assembles the site for tests."
            task.app.set(app.flatMap { it.replaced })
            task.site.set(build.dir("assembled-site"))
        }
    }

    /** `assembleRelease`: the same, small and fast. `dist`: the folder to upload, with compressed files. */
    fun addRelease(): TaskProvider<AssembleSite> {
        val link = project.tasks.named(LINK, KotlinJsIrLink::class.java)
        val optimize = project.tasks.register(OPTIMIZE, OptimizeWasm::class.java) { task ->
            task.description = "Makes the app's wasm small and fast."
            task.linked.set(link.flatMap { it.destinationDirectory.file(APP) })
            task.arguments.set(WasmOptimisation.arguments(project, WasmOptimisation.RELEASE_PASSES))
            task.optimized.set(build.file("optimized-app/$APP"))
        }
        val split = split("splitRelease", DividedModule.APP, build.dir("optimized-app"))
        split.configure { it.dependsOn(optimize) }
        val app = replace(
            "releaseApp",
            "Puts the parts of the small and fast modules into what webpack has made.",
            splitSkiko.flatMap { it.parts },
            split.flatMap { it.parts },
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

    /** `recordFirstPart`: finds the functions that belong into the first parts of the modules; run by hand. */
    fun addRecording() {
        val optimize = project.tasks.named(OPTIMIZE, OptimizeWasm::class.java)
        val whole =
            replace(
                "wholeRelease",
                "Puts the optimised app into what webpack has made.",
                optimize.flatMap { it.optimized },
            )
        val page = addMarked("Site", project.layout.dir(builtApp))
        val published = addMarked("Release", whole.flatMap { it.replaced })
        project.tasks.register("recordFirstPart", RecordFirstPart::class.java) { task ->
            task.group = "build setup"
            task.description = "Finds out which functions the first minute of the page calls."
            task.page.set(page.flatMap { it.site })
            task.app.fileProvider(builtApp)
            task.published.set(published.flatMap { it.site })
            task.publishedApp.set(whole.flatMap { it.replaced })
            task.script.set(project.file("src/browserTest/record-first-part.mjs"))
            task.lists.set(lists)
        }
    }

    /** A site with the modules of [app], which tell which of their functions are called. */
    private fun addMarked(name: String, app: Provider<Directory>): TaskProvider<AssembleSite> {
        val mark = project.tasks.register("mark$name", MarkCalls::class.java) { task ->
            task.description = "Makes modules that tell which of their functions are called."
            task.app.set(app)
            task.marked.set(build.dir("marked/$name"))
        }
        val marked =
            replace("marked$name", "Puts marked modules into what webpack has made.", mark.flatMap { it.marked })
        return project.tasks.register("assembleMarked$name", AssembleSite::class.java) { task ->
            task.description = "Assembles a site with marked modules."
            task.app.set(marked.flatMap { it.replaced })
            task.site.set(build.dir("assembled-marked/$name"))
        }
    }

    private fun split(name: String, module: DividedModule, folder: Provider<Directory>): TaskProvider<SplitWasm> =
        project.tasks.register(name, SplitWasm::class.java) { task ->
            task.description = "Splits ${module.stem}.wasm into what the first minute calls and the rest."
            task.app.set(folder)
            task.stem.set(module.stem)
            task.lists.set(lists)
            task.parts.set(build.dir("parts/$name"))
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
        const val OPTIMIZE = "optimizeApp"
    }
}
