import josx.platform.rcx.LCD;

public class Inheritance {
    static class Animal {
        int legs = 4;

        int sound() {
            return 1;
        }

        int twice() {
            return sound() * 2;
        }
    }

    static class Bird extends Animal {
        Bird() {
            legs = 2;
        }

        int sound() {
            return super.sound() + 10;
        }
    }

    static class Parrot extends Bird {
        int sound() {
            return super.sound() + 100;
        }
    }

    public static void main(String[] arguments) {
        Animal animal = new Animal();
        LCD.showNumber(animal.twice()); // shows: 2
        animal = new Bird();
        LCD.showNumber(animal.twice()); // shows: 22
        LCD.showNumber(animal.legs); // shows: 2
        animal = new Parrot();
        LCD.showNumber(animal.twice()); // shows: 222
    }
}
