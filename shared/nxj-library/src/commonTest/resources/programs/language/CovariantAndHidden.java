public class CovariantAndHidden {
    static class Base implements Cloneable {
        int value = 1;
        static String kind = "base";

        Base self() {
            return this;
        }

        Object get() {
            return value;
        }

        static String told() {
            return "Base.told";
        }

        private String secret() {
            return "base secret";
        }

        String reveal() {
            return secret() + " " + value;
        }

        @Override
        public Base clone() throws CloneNotSupportedException {
            return (Base) super.clone();
        }
    }

    static class Derived extends Base {
        int value = 2;
        static String kind = "derived";

        @Override
        Derived self() {
            return this;
        }

        @Override
        String get() {
            return "got " + value + " " + super.value + " " + super.get();
        }

        static String told() {
            return "Derived.told";
        }

        private String secret() {
            return "derived secret";
        }

        String both() {
            return secret() + ", " + reveal();
        }
    }

    public static void main(String[] arguments) throws CloneNotSupportedException {
        Derived derived = new Derived();
        Base base = derived;
        System.out.println(base.value + " " + derived.value + " " + ((Base) derived).value); // expect 1 2 1
        System.out.println(base.get()); // expect got 2 1 1
        System.out.println(derived.self().value + " " + base.self().value); // expect 2 1
        System.out.println(Base.told() + " " + Derived.told() + " " + Base.kind + " " + Derived.kind); // expect Base.told Derived.told base derived
        System.out.println(derived.both()); // expect derived secret, base secret 1
        Base copy = base.clone();
        System.out.println((copy instanceof Derived) + " " + (copy != base) + " " + copy.get()); // expect true true got 2 1 1
    }
}
