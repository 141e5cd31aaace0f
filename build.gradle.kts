plugins {
    id("robotran.root")
}
