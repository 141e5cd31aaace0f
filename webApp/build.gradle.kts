plugins {
    id("robotran.web")
}

kotlin {
    sourceSets {
        wasmJsMain.dependencies {
            implementation(project(":shared:ui"))
            implementation(libs.coroutines.core)
        }
    }
}
