#include "app/ui/figures/texbind_calls.h"

namespace texplorer::ui {

const std::vector<ToldCall>& texbindCalls() {
    using namespace objects;
    constexpr const char* given = "glTexParameteri changes the object that is bound: it keeps the value.";
    constexpr const char* image = "glTexImage2D gives the bound object its image.";
    static const std::vector<ToldCall> calls{
        {GenTexture{}, "A name and nothing more: there is no object yet."},
        {GenTexture{}, "texbind.c asks for two names."},
        {BindTexture{1}, "The first glBindTexture of a name makes the object, with OpenGL's initial values."},
        {setWrapS(Wrap::Clamp), given},
        {setWrapT(Wrap::Clamp), given},
        {setParameter(MagFilter::Nearest), given},
        {setParameter(MinFilter::Nearest),
         "With the initial filter, which wants mipmaps, it would be incomplete."},
        {GiveImage{0}, image},
        {BindTexture{2}, "A new object begins with the initial values again, whatever the first one has."},
        {setWrapS(Wrap::Clamp), given},
        {setWrapT(Wrap::Clamp), given},
        {setParameter(MagFilter::Nearest), given},
        {setParameter(MinFilter::Nearest), given},
        {GiveImage{1}, image},
        {SetEnvMode{EnvMode::Decal}, "Set once, while object 2 is bound; but glTexEnvi changes the unit."},
        {EnableTexture{true}, "glEnable is the unit's as well."},
        {BindTexture{1},
         "Object 1 comes back with its image and its filters; the unit still has its environment."},
        {BindTexture{2}, "Object 2 comes back: the environment, set only once, holds for both."},
    };
    return calls;
}

} // namespace texplorer::ui
