plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:programs"))
            api(project(":shared:world"))
        }
    }
}
