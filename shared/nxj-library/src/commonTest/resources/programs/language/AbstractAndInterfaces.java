public class AbstractAndInterfaces {
    interface Named {
        String PREFIX = "I am ";

        String name();
    }

    interface Sized extends Comparable<Sized> {
        int size();
    }

    abstract static class Animal implements Named, Sized {
        public int compareTo(Sized other) {
            return size() - other.size();
        }

        @Override
        public String toString() {
            return PREFIX + name() + sound();
        }

        protected abstract String sound();
    }

    static class Dog extends Animal {
        public String name() {
            return "a dog";
        }

        public int size() {
            return 50;
        }

        protected String sound() {
            return "!";
        }
    }

    static class Puppy extends Dog {
        @Override
        public int size() {
            return super.size() / 2;
        }

        @Override
        public String name() {
            return "not " + super.name();
        }
    }

    static String over(Animal animal) {
        return "animal";
    }

    static String over(Dog dog) {
        return "dog";
    }

    public static void main(String[] arguments) {
        Animal dog = new Dog();
        Sized puppy = new Puppy();
        System.out.println(dog); // expect I am a dog!
        System.out.println(puppy); // expect I am not a dog!
        System.out.println(dog.compareTo(puppy)); // expect 25
        System.out.println(over(dog) + " " + over((Dog) dog) + " " + over(new Puppy())); // expect animal dog dog
        System.out.println(puppy instanceof Named); // expect true
        System.out.println(dog instanceof Puppy); // expect false
        Named named = (Named) puppy;
        System.out.println(named.name()); // expect not a dog
        try {
            System.out.println(((Puppy) dog).size());
        } catch (ClassCastException wrong) {
            System.out.println("only a dog"); // expect only a dog
        }
        System.out.println(dog.getClass() == puppy.getClass()); // expect false
        System.out.println(dog.getClass() == Dog.class); // expect true
        System.out.println(puppy.getClass().getSuperclass() == Dog.class); // expect true
        System.out.println(Animal.class.isInstance(puppy)); // expect true
    }
}
