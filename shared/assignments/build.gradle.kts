plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant("jvmTest", "robotran.assignments.schemaTexts", "worlds", "*.schema.json")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:learning"))
            api(project(":shared:documents"))
            api(project(":shared:projects"))
            api(project(":shared:simulation"))
        }
        jvmTest.dependencies {
            implementation(libs.json.schema.validator)
        }
    }
}
