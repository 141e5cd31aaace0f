plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.microbit.documents", "docs", "microbit.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:brick"))
            api(project(":shared:language"))
        }
    }
}
