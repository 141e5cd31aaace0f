plugins {
    id("java-gradle-plugin")
    id("org.jetbrains.kotlin.jvm")
}

dependencies {
    implementation(project(":jvm"))
    implementation(libs.plugin.android)
    implementation(libs.plugin.android.builder) // for R8
    implementation(libs.apksig)
    implementation(libs.animal.sniffer)
    implementation(libs.dexlib)
    testImplementation(libs.kotlin.test)
}

tasks.test {
    useJUnitPlatform()
}

gradlePlugin {
    testSourceSets()
    plugins {
        create("androidLibrary") {
            id = "robotran.android.library"
            implementationClass = "robotran.build.android.AndroidLibraryPlugin"
        }
        create("androidApp") {
            id = "robotran.android.app"
            implementationClass = "robotran.build.android.AndroidAppPlugin"
        }
        create("androidReferences") {
            id = "robotran.android.references"
            implementationClass = "robotran.build.android.AndroidReferencesPlugin"
        }
    }
}
