plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.world.worldTexts", "worlds", "*.world.json")
    constant("commonTest", "robotran.world.pages", "docs", "worlds.md")
    constant("commonTest", "robotran.world.exampleTexts", "examples", "*.robo")
    constant("commonTest", "robotran.world.expectedRuns", "shared/world/src/commonTest/resources/runs", "*")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            implementation(libs.serialization.json)
        }
        commonTest.dependencies {
            implementation(project(":shared:robolang"))
        }
        jvmMain.dependencies {
            implementation(project(":shared:physics"))
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
