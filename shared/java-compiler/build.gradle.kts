plugins {
    id("robotran.core")
    id("robotran.ecj-web")
}

kotlin {
    sourceSets {
        jvmMain.dependencies {
            implementation(project(":shared:ecj"))
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
