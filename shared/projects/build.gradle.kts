plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.projects.recordedProjects", "shared/projects/src/commonTest/resources/runs", "*")
    blocks("commonTest", "robotran.projects.documentedProjects", "docs", "worlds.md", "robotran")
    blocks("commonTest", "robotran.projects.documentedAssignments", "docs", "assignments.md", "robotran")
    blocks("commonTest", "robotran.projects.documentedCourses", "docs", "assignments.md", "robotran course")
    constant("jvmTest", "robotran.projects.schemaTexts", "worlds", "*.schema.json")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:programs"))
            api(project(":shared:simulation"))
        }
        jvmTest {
            kotlin.srcDir("../json/src/schemaTest/kotlin")
        }
        jvmTest.dependencies {
            implementation(project(":shared:nxt"))
            implementation(project(":shared:lego-firmware"))
            implementation(libs.json.schema.validator)
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
