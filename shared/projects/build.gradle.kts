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
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:programs"))
            api(project(":shared:simulation"))
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
