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
        System.out.println(animal.twice()); // expect 2
        animal = new Bird();
        System.out.println(animal.twice()); // expect 22
        System.out.println(animal.legs); // expect 2
        animal = new Parrot();
        System.out.println(animal.twice()); // expect 222
    }
}
