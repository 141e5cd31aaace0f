plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.physics-web")
    id("robotran.texts")
    id("robotran.brick-programs")
}

texts {
    constant("commonMain", "robotran.world.worldTexts", "worlds", "*.world.json")
    constant("jvmTest", "robotran.world.file.schemaTexts", "worlds", "*.schema.json")
    blocks("commonTest", "robotran.world.documentedWorlds", "docs", "worlds.md", "json")
    constant("commonTest", "robotran.world.penbotPages", "docs", "penbot.md")
    constant("commonTest", "robotran.world.exampleTexts", "examples", "*.robo")
    constant("commonTest", "robotran.world.expectedRuns", "shared/world/src/commonTest/resources/runs", "*")
}

brickPrograms {
    constant("commonTest", "robotran.world.steppedPrograms", "shared/world/src/commonTest/resources/java")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:json"))
        }
        commonTest.dependencies {
            implementation(project(":shared:robolang"))
            implementation(project(":shared:tinyvm"))
            implementation(project(":shared:lejos-library"))
        }
        jvmTest.dependencies {
            implementation(libs.json.schema.validator)
        }
        jvmMain.dependencies {
            implementation(project(":shared:physics"))
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
