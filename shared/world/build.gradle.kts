plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.world.worldTexts", "worlds", "*.world.json")
    constant("commonTest", "robotran.world.pages", "docs", "worlds.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            implementation(libs.serialization.json)
        }
        jvmMain.dependencies {
            implementation(project(":shared:physics"))
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
