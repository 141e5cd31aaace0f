plugins {
    id("java-gradle-plugin")
    alias(libs.plugins.kotlin.jvm)
}

dependencies {
    implementation(libs.plugin.kotlin)
    testImplementation(libs.kotlin.test)
}

tasks.test {
    useJUnitPlatform()
}

gradlePlugin {
    testSourceSets() // none: the tests are plain unit tests, and an embedded Gradle has no TestKit
    plugins {
        create("root") {
            id = "robotran.root"
            implementationClass = "robotran.build.RootPlugin"
        }
        create("core") {
            id = "robotran.core"
            implementationClass = "robotran.build.CorePlugin"
        }
        create("testPrograms") {
            id = "robotran.test-programs"
            implementationClass = "robotran.build.TestProgramsPlugin"
        }
    }
}
