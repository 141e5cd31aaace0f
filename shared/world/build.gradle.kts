plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.world.file.worldTexts", "worlds", "*.world.json")
    constant("jvmTest", "robotran.world.file.schemaTexts", "worlds", "*.schema.json")
    blocks("commonTest", "robotran.world.file.documentedWorlds", "docs", "worlds.md", "json")
    constant("commonTest", "robotran.world.file.robotTexts", "worlds", "*.robot.json")
    blocks("commonTest", "robotran.world.file.documentedRobots", "docs", "robots.md", "json")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:brick"))
            api(project(":shared:json"))
        }
        jvmTest {
            kotlin.srcDir("src/arbitraryWorlds/kotlin")
            kotlin.srcDir("../json/src/schemaTest/kotlin")
        }
        jvmTest.dependencies {
            implementation(libs.json.schema.validator)
        }
    }
}
