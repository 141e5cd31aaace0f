plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant(
        "commonMain",
        "robotran.assignments.packaging.wrapperTexts",
        "shared/assignments/src/learningPackage",
        "*",
    )
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:learning"))
            api(project(":shared:documents"))
            api(project(":shared:projects"))
            api(project(":shared:simulation"))
        }
    }
}
